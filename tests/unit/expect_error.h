// Shared by tests of what is refused.

#ifndef stickslip_tests_expect_error_h
#define stickslip_tests_expect_error_h

#include <stickslip/base/user_error.h>

#include "print.h"

#include <functional>
#include <string>

namespace
{
  /// Prints the message of the UserError that @p make has to throw.
  inline void
  expect_error(const std::function<void()> &make)
  {
    try
      {
        make();
        print("  no error: NO");
      }
    catch (const stickslip::UserError &error)
      {
        print(std::string("  ") + error.what());
      }
  }
} // namespace

#endif
