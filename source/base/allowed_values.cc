#include <stickslip/base/allowed_values.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <exception>

namespace stickslip
{
  namespace
  {
    bool
    begins_with(const std::string &text, const std::string &beginning)
    {
      return text.compare(0, beginning.size(), beginning) == 0;
    }



    /// The text between @p beginning and @p end; empty if they are not there.
    std::string
    enclosed_text(const std::string &text,
                  const std::string &beginning,
                  const std::string &end)
    {
      const std::size_t first = text.find(beginning);
      const std::size_t last  = text.rfind(end);
      if (first == std::string::npos || last == std::string::npos ||
          last < first + beginning.size())
        return "";
      return text.substr(first + beginning.size(),
                         last - first - beginning.size());
    }



    /// "0...MAX_DOUBLE" -> ">= 0", without the bounds that mean none.
    std::string
    range_in_words(const std::string &range)
    {
      const std::size_t dots = range.find("...");
      if (dots == std::string::npos)
        return "";
      const std::string lower = range.substr(0, dots);
      const std::string upper = range.substr(dots + 3);
      const bool has_lower = (lower != "-MAX_DOUBLE" && lower != "-2147483648");
      const bool has_upper = (upper != "MAX_DOUBLE" && upper != "2147483647" &&
                              upper != "4294967295");

      if (has_lower && has_upper)
        return lower == upper ? " equal to " + lower
                              : " from " + lower + " to " + upper;
      return has_lower ? " >= " + lower : has_upper ? " <= " + upper : "";
    }



    /// "[List of <[Bool]> of length 0...3 (inclusive) separated by <;>]"
    std::string
    list_in_words(const std::string &pattern)
    {
      const std::string element =
        enclosed_text(pattern, "[List of <", "> of length ");
      // The elements may be lists, too: their lengths come first.
      const std::size_t end = pattern.rfind("> of length ");
      if (end == std::string::npos)
        return pattern;
      const std::string tail = pattern.substr(end);
      const std::string length =
        enclosed_text(tail, "> of length ", " (inclusive)");
      std::string separator =
        enclosed_text(tail, "(inclusive) separated by <", ">]");
      separator = separator.empty() ? "commas" : "'" + separator + "'";

      const std::string count =
        begins_with(length, "0...") && length != "0...0" &&
            range_in_words(length) == " >= 0"
          ? ""
          : "; number of values" + range_in_words(length);
      return "a list separated by " + separator +
             ", each: " + allowed_values_of_pattern(element) + count;
    }



    std::string
    joined_choices(const std::vector<std::string> &choices)
    {
      std::string words;
      for (const std::string &choice : choices)
        words += (words.empty() ? "" : " | ") + choice;
      return words;
    }
  } // namespace



  std::string
  allowed_values_of_pattern(const std::string &pattern)
  {
    if (begins_with(pattern, "[Anything"))
      return "any text";
    if (begins_with(pattern, "[Selection "))
      return joined_choices(choices_of_pattern(pattern));
    if (begins_with(pattern, "[Bool"))
      return "true or false";
    if (begins_with(pattern, "[FileName"))
      return "a file name";
    if (begins_with(pattern, "[DirectoryName"))
      return "a directory name";
    if (begins_with(pattern, "[Integer range "))
      return "an integer" +
             range_in_words(
               enclosed_text(pattern, "[Integer range ", " (inclusive)"));
    if (begins_with(pattern, "[Integer"))
      return "an integer";
    if (begins_with(pattern, "[Double "))
      return "a number" +
             range_in_words(enclosed_text(pattern, "[Double ", " (inclusive)"));
    if (begins_with(pattern, "[Double"))
      return "a number";
    if (begins_with(pattern, "[List of <"))
      return list_in_words(pattern);
    if (begins_with(pattern, "[Tuple of <"))
      return "numbers separated by ':'"; // deal.II cannot read its own text
    try
      {
        return dealii::Patterns::pattern_factory(pattern)->description(
          dealii::Patterns::PatternBase::Text);
      }
    catch (const std::exception &)
      {
        return pattern; // a pattern of a derived class
      }
  }



  std::vector<std::string>
  choices_of_pattern(const std::string &description)
  {
    return begins_with(description, "[Selection ")
             ? dealii::Utilities::split_string_list(
                 enclosed_text(description, "[Selection ", "]"), '|')
             : std::vector<std::string>();
  }
} // namespace stickslip
