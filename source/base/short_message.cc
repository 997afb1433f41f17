#include <stickslip/base/short_message.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <sstream>

namespace stickslip
{
  namespace
  {
    std::string
    without_middle(const std::string &text, const std::size_t most)
    {
      if (text.size() <= most)
        return text;
      const std::size_t head = most / 2, tail = most / 8;
      return text.substr(0, head) + "[... " +
             std::to_string(text.size() - head - tail) + " characters ...]" +
             text.substr(text.size() - tail);
    }
  } // namespace



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



  std::string
  without_long_words(const std::string &text)
  {
    constexpr std::size_t longest_word = 400, longest_text = 20000;
    std::string           result;
    std::size_t           position = 0;
    while (position < text.size())
      {
        const std::size_t end =
          std::min(text.find_first_of(" \n", position), text.size());
        result +=
          without_middle(text.substr(position, end - position), longest_word);
        if (end < text.size())
          result += text[end];
        position = end + 1;
      }
    return without_middle(result, longest_text);
  }
} // namespace stickslip
