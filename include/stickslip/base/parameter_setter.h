#ifndef stickslip_base_parameter_setter_h
#define stickslip_base_parameter_setter_h

#include <stickslip/base/declared_parameters.h>
#include <stickslip/base/parameter_file_reader.h>

#include <deal.II/base/parameter_handler.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * Holds the statements of a file against what is declared, sets what is
   * right and collects the messages about what is wrong.
   */
  class ParameterSetter
  {
  public:
    explicit ParameterSetter(dealii::ParameterHandler &prm)
      : prm(prm)
      , declared(declared_parameters(prm))
    {}

    void
    check_section(const ParameterStatement &statement);

    void
    set(const ParameterStatement &entry);

    void
    add_error(const ParameterStatement &statement, const std::string &text);

    /// One message per line, in the order of the file, `--set` last.
    std::string
    errors() const;

  private:
    /// nullptr, after a message, if the section is not declared.
    const DeclaredSection *
    find_section(const ParameterStatement &statement);

    void
    report_unknown_name(const ParameterStatement &entry,
                        const DeclaredSection    &section);

    dealii::ParameterHandler &prm;
    const DeclaredSection     declared;

    std::vector<std::pair<ParameterStatement, std::string>> messages;

    /// An unknown section is one mistake, whatever it contains.
    std::set<std::vector<std::string>> reported_sections;
  };
} // namespace stickslip

#endif
