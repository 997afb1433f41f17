#include <stickslip/base/short_message.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace stickslip
{
  std::string
  short_message(const std::exception &exception)
  {
    std::string text = exception.what();
    if (const auto *deal_exception =
          dynamic_cast<const dealii::ExceptionBase *>(&exception))
      {
        std::ostringstream info;
        deal_exception->print_info(info);
        text = info.str();
        // Many of deal.II's checks have no message but their condition.
        if (text.find_first_not_of(" \n(none)") == std::string::npos)
          text = std::string("deal.II: ") + deal_exception->get_exc_name();
      }

    std::string        message, word;
    std::istringstream words(text);
    while (words >> word)
      message += (message.empty() ? "" : " ") + word;
    return message;
  }
} // namespace stickslip
