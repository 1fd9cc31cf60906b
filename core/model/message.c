/* Texts of failures. */
#include "message.h"

#include <stdarg.h>
#include <stdio.h>

maggi_status maggi_message(maggi_status status, char *message, size_t n, const char *format, ...)
{
  va_list args;

  va_start(args, format);
  vsnprintf(message, n, format, args);
  va_end(args);
  return status;
}

maggi_status maggi_message_memory(char *message, size_t n)
{
  return maggi_message(MAGGI_E_MEMORY, message, n, "out of memory");
}
