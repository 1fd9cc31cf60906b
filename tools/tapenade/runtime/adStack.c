/* Bytes are numbered from the bottom of the stack; block k holds FIRST << k of them.  A record of the
 * stack itself lies among the values: a mark of startRepeat, or where to go on after a detour around
 * what a mark keeps. */
#include "adStack.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST = 4096, BLOCKS = 32 };

/* a place to return to; outer: the mark around a mark */
typedef struct record {
  size_t top, detour, outer;
} record;

static _Thread_local struct {
  size_t top;    /* one above the last byte */
  size_t detour; /* one above the record of the last detour, 0: none; below top */
  size_t mark;   /* one above the record of the last mark, 0: none; what lies below is kept */
  int failed;
  char *block[BLOCKS];
  char first[FIRST];
} stack;

static void release(void)
{
  int k;

  for (k = 0; k < BLOCKS; ++k) {
    if (stack.block[k] != stack.first) free(stack.block[k]);
    stack.block[k] = NULL;
  }
  stack.top = stack.detour = stack.mark = 0;
}

static void fail(void)
{
  release();
  stack.failed = 1;
}

/* where byte `at` is and how many follow it in its block; its block is there after reserve */
static char *locate(size_t at, size_t *room)
{
  size_t size = FIRST;
  int k = 0;

  while (at >= size) {
    at -= size;
    size *= 2;
    ++k;
  }
  *room = size - at;
  return stack.block[k] + at;
}

/* blocks up to byte `end` */
static int reserve(size_t end)
{
  size_t size = FIRST, sum = 0;
  int k;

  for (k = 0; k < BLOCKS && sum < end; ++k) {
    if (!stack.block[k]) stack.block[k] = k == 0 ? stack.first : malloc(size);
    if (!stack.block[k]) return 0;
    sum += size;
    size *= 2;
  }
  return sum >= end;
}

static void store(size_t at, const void *x, size_t n)
{
  const char *from = x;
  size_t room;
  char *to;

  while (n > 0) {
    to = locate(at, &room);
    if (room > n) room = n;
    memcpy(to, from, room);
    from += room;
    at += room;
    n -= room;
  }
}

static void fetch(size_t at, void *x, size_t n)
{
  const char *from;
  size_t room;
  char *to = x;

  while (n > 0) {
    from = locate(at, &room);
    if (room > n) room = n;
    memcpy(to, from, room);
    to += room;
    at += room;
    n -= room;
  }
}

/* the record of a detour or a mark goes above all that is kept */
static size_t store_record(void)
{
  const record r = {stack.top, stack.detour, stack.mark};
  const size_t at = stack.top > stack.mark ? stack.top : stack.mark;

  if (!reserve(at + sizeof r)) {
    fail();
    return 0;
  }
  store(at, &r, sizeof r);
  return at + sizeof r;
}

static record fetch_record(size_t end)
{
  record r;

  fetch(end - sizeof r, &r, sizeof r);
  return r;
}

static void release_empty(void)
{
  if (stack.top == 0 && stack.mark == 0) release();
}

static void push(const void *x, size_t n)
{
  if (stack.failed || n == 0) return;
  if (stack.top < stack.mark) {
    stack.top = stack.detour = store_record();
    if (stack.failed) return;
  }
  if (!reserve(stack.top + n)) {
    fail();
    return;
  }
  store(stack.top, x, n);
  stack.top += n;
}

/* 0 where there is nothing to pop */
static int pop(void *x, size_t n)
{
  record r;

  if (n == 0) return 1;
  if (!stack.failed && stack.top - stack.detour < n) fail();
  if (stack.failed) {
    memset(x, 0, n);
    return 0;
  }
  stack.top -= n;
  fetch(stack.top, x, n);
  if (stack.detour > 0 && stack.top == stack.detour) {
    r = fetch_record(stack.detour);
    stack.top = r.top;
    stack.detour = r.detour;
  }
  release_empty();
  return 1;
}

static size_t bytes(int n, size_t size)
{
  return n > 0 ? (size_t)n * size : 0;
}

void pushReal8Array(double *x, int n)
{
  push(x, bytes(n, sizeof *x));
}

void popReal8Array(double *x, int n)
{
  int i;

  if (!pop(x, bytes(n, sizeof *x)))
    for (i = 0; i < n; ++i) x[i] = NAN;
}

void pushReal4Array(float *x, int n)
{
  push(x, bytes(n, sizeof *x));
}

void popReal4Array(float *x, int n)
{
  int i;

  if (!pop(x, bytes(n, sizeof *x)))
    for (i = 0; i < n; ++i) x[i] = NAN;
}

void pushInteger4Array(int *x, int n)
{
  push(x, bytes(n, sizeof *x));
}

void popInteger4Array(int *x, int n)
{
  pop(x, bytes(n, sizeof *x));
}

void pushInteger8Array(long *x, int n)
{
  push(x, bytes(n, sizeof *x));
}

void popInteger8Array(long *x, int n)
{
  pop(x, bytes(n, sizeof *x));
}

void pushReal8(double x)
{
  push(&x, sizeof x);
}

void popReal8(double *x)
{
  popReal8Array(x, 1);
}

void pushReal4(float x)
{
  push(&x, sizeof x);
}

void popReal4(float *x)
{
  popReal4Array(x, 1);
}

void pushInteger4(int x)
{
  push(&x, sizeof x);
}

void popInteger4(int *x)
{
  pop(x, sizeof *x);
}

void pushInteger8(long x)
{
  push(&x, sizeof x);
}

void popInteger8(long *x)
{
  pop(x, sizeof *x);
}

void pushPointer8(void *x)
{
  push(&x, sizeof x);
}

void popPointer8(void **x)
{
  if (!pop(x, sizeof *x)) *x = NULL;
}

void pushReal8_d(double x, double xd)
{
  pushReal8(x);
  pushReal8(xd);
}

void popReal8_d(double *x, double *xd)
{
  popReal8(xd);
  popReal8(x);
}

void pushReal8Array_d(double *x, double *xd, int n)
{
  pushReal8Array(x, n);
  pushReal8Array(xd, n);
}

void popReal8Array_d(double *x, double *xd, int n)
{
  popReal8Array(xd, n);
  popReal8Array(x, n);
}

void pushControl1b(int x)
{
  const unsigned char way = (unsigned char)x;

  push(&way, sizeof way);
}

void popControl1b(int *x)
{
  unsigned char way;

  pop(&way, sizeof way);
  *x = way;
}

void adStack_startRepeat(void)
{
  if (!stack.failed) stack.mark = store_record();
}

void adStack_resetRepeat(void)
{
  record r;

  if (stack.failed || stack.mark == 0) return;
  r = fetch_record(stack.mark);
  stack.top = r.top;
  stack.detour = r.detour;
}

void adStack_endRepeat(void)
{
  if (stack.failed || stack.mark == 0) return;
  stack.mark = fetch_record(stack.mark).outer;
  release_empty();
}

int adStack_failed(void)
{
  return stack.failed;
}

void adStack_clear(void)
{
  release();
  stack.failed = 0;
}
