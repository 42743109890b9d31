#include <libhair/files/obj.h>
