#ifndef stickslip_base_registry_h
#define stickslip_base_registry_h

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The implementations of one concept that the user chooses by name. Filled
   * where the concept is at home, with an explicit list (a library drops
   * objects that register themselves), for example
   * @code
   *   const Registry<ConstitutiveLaw> &
   *   constitutive_laws()
   *   {
   *     static const Registry<ConstitutiveLaw> registry(
   *       "constitutive law",
   *       {{"linear elastic", "Hooke's law for small strains",
   *         [] { return std::make_unique<LinearElastic>(); }}});
   *     return registry;
   *   }
   * @endcode
   */
  template <typename Product, typename... Arguments>
  class Registry
  {
  public:
    using Factory = std::function<std::unique_ptr<Product>(Arguments...)>;

    struct Entry
    {
      std::string name;
      std::string description;
      Factory     factory;
    };

    /// @p kind says in messages what the names stand for.
    Registry(const std::string &kind, std::vector<Entry> entries)
      : kind(kind)
      , entries(std::move(entries))
    {}

    /// One more, behind the others; false, and nothing added, if there is one
    /// of this name.
    bool
    add(Entry entry)
    {
      for (const Entry &known : entries)
        if (known.name == entry.name)
          return false;
      entries.push_back(std::move(entry));
      return true;
    }

    /**
     * A new object of the kind called @p name. Throws UserError, with the
     * nearest and the known names, for an unknown name; @p parameter_path
     * ("Materials/steel/Law") says where the name was found.
     */
    std::unique_ptr<Product>
    create(const std::string &name,
           const std::string &parameter_path,
           Arguments... arguments) const
    {
      for (const Entry &entry : entries)
        if (entry.name == name)
          return entry.factory(std::forward<Arguments>(arguments)...);
      throw UserError("'" + parameter_path + "': unknown " + kind + " '" +
                      name + "'." + did_you_mean(name, names()) +
                      " Known: " + quoted_list(names()) + ".");
    }

    /// The known names in the order of the list.
    std::vector<std::string>
    names() const
    {
      std::vector<std::string> result;
      for (const Entry &entry : entries)
        result.push_back(entry.name);
      return result;
    }

    /// "a|b|c", for Patterns::Selection.
    std::string
    selection() const
    {
      std::string result;
      for (const Entry &entry : entries)
        result += (result.empty() ? "" : "|") + entry.name;
      return result;
    }

    /// "a: what a is; b: what b is.", for the documentation of a parameter.
    std::string
    descriptions() const
    {
      std::string result;
      for (const Entry &entry : entries)
        result +=
          (result.empty() ? "" : "; ") + entry.name + ": " + entry.description;
      return result + ".";
    }

  private:
    std::string        kind;
    std::vector<Entry> entries;
  };
} // namespace stickslip

#endif
