#include <stickslip/solid/space_time_function.h>
