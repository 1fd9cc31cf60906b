/* Call a function of MuJoCo n times; for peers.py, where a call from Python costs a microsecond. */
void maggi_repeat(void (*function)(const void *, void *), const void *m, void *d, int n);

void maggi_repeat(void (*function)(const void *, void *), const void *m, void *d, int n)
{
  int i;

  for (i = 0; i < n; ++i)
    function(m, d);
}
