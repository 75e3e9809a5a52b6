#include "constants.h" // expect error MP021
