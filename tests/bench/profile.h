/* Where an evaluation goes: microseconds and flops of each function of the kernel. */
#ifndef BENCH_PROFILE_H
#define BENCH_PROFILE_H

#include "cases.h"

extern const char *const profile_function[STAGED_COUNT];

/* Print them as a table; in a build without staged.c a line that says so. */
void profile(int markdown, bench_case *c);

#endif
