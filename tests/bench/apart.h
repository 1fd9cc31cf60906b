/* A model measured in a process of its own: the memory of ADOL-C remembers all models before. */
#ifndef MAGGI_BENCH_APART_H
#define MAGGI_BENCH_APART_H

/* run(options, name) there: 0 when it returns 0 and all that it has written has arrived. */
int run_apart(int (*run)(const void *options, const char *name), const void *options,
              const char *name);

#endif
