/* Texts of failures. */
#ifndef MAGGI_MESSAGE_H
#define MAGGI_MESSAGE_H

#include "maggi/maggi.h"

/* Fills message (n chars) and returns status. */
maggi_status maggi_message(maggi_status status, char *message, size_t n, const char *format, ...);
maggi_status maggi_message_memory(char *message, size_t n);

#endif
