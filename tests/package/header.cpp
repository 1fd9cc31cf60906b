// The public header read by C++.
#include <maggi/maggi.h>

#include <cstring>

int main()
{
  maggi_builder *b = nullptr;

  if (maggi_builder_create("empty", &b) != MAGGI_OK) return 1;
  maggi_builder_free(b);
  return std::strcmp(maggi_status_text(MAGGI_OK), "success");
}
