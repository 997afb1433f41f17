#ifndef stickslip_base_choice_h
#define stickslip_base_choice_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * The values of an enum with the names that they have in a parameter file, in
   * the order in which they are documented. Filled where the enum is at home,
   * for example
   * @code
   *   enum class Normals { facet, smoothed };
   *
   *   const Choices<Normals> &
   *   all_normals()
   *   {
   *     static const Choices<Normals> choices = {
   *       {"facet", Normals::facet}, {"smoothed", Normals::smoothed}};
   *     return choices;
   *   }
   * @endcode
   */
  template <typename Enum>
  using Choices = std::vector<std::pair<std::string, Enum>>;



  /// The name of @p value among @p choices.
  template <typename Enum>
  const std::string &
  name_of(const Enum value, const Choices<Enum> &choices)
  {
    for (const auto &choice : choices)
      if (choice.second == value)
        return choice.first;
    throw ExcInternalError();
  }



  /// The value called @p name among @p choices.
  template <typename Enum>
  Enum
  value_of(const std::string &name, const Choices<Enum> &choices)
  {
    for (const auto &choice : choices)
      if (choice.first == name)
        return choice.second;
    throw ExcInternalError();
  }



  /// The names of @p choices, in their order.
  template <typename Enum>
  std::vector<std::string>
  names_of(const Choices<Enum> &choices)
  {
    std::vector<std::string> names;
    for (const auto &choice : choices)
      names.push_back(choice.first);
    return names;
  }



  /**
   * Declares the entry @p name, which takes one of the names of @p choices; its
   * default is the present @p value. As with ParameterHandler::add_parameter,
   * @p value follows the entry and must live as long as @p prm is read, as must
   * @p choices.
   */
  template <typename Enum>
  void
  add_choice(ParameterHandler    &prm,
             const std::string   &name,
             Enum                &value,
             const Choices<Enum> &choices,
             const std::string   &documentation)
  {
    std::string names;
    for (const auto &choice : choices)
      names += (names.empty() ? "" : "|") + choice.first;
    prm.declare_entry(name,
                      name_of(value, choices),
                      Patterns::Selection(names),
                      documentation);
    prm.add_action(name, [&value, &choices](const std::string &chosen) {
      value = value_of(chosen, choices);
    });
  }
} // namespace stickslip

#endif
