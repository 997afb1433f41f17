#ifndef stickslip_strategy_back_off_h
#define stickslip_strategy_back_off_h

namespace stickslip
{
  /**
   * Exponential back-off: how many load steps to wait before something that has
   * failed is tried again. Each failure doubles the wait, up to a longest one;
   * each time that it succeeds again the next wait is half as long.
   */
  class BackOff
  {
  public:
    /// Nothing has failed yet. After the first failure the wait takes
    /// @p first steps, and never more than @p longest.
    BackOff(const unsigned int first, const unsigned int longest)
      : first(first)
      , longest(longest)
    {}

    /// A wait twice as long as the last one begins.
    void
    fail();

    /// What was waited for has succeeded: waits become half as long.
    void
    succeed();

    /// A step of the wait is over.
    void
    advance();

    /// The wait begins again, as long as before.
    void
    restart()
    {
      left = length;
    }

    bool
    is_waiting() const
    {
      return left > 0;
    }

    /// Steps of a whole wait.
    unsigned int
    wait_length() const
    {
      return length;
    }

    /// Steps of the present wait that are left.
    unsigned int
    steps_left() const
    {
      return left;
    }

    /// Continues at what wait_length() and steps_left() have returned.
    void
    resume(const unsigned int wait_length, const unsigned int steps_left);

  private:
    unsigned int first;
    unsigned int longest;
    unsigned int length = 0;
    unsigned int left   = 0;
  };
} // namespace stickslip

#endif
