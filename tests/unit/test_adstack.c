/* The stack of adjoint code: what is pushed comes back in reverse order, kept parts come back again,
 * threads do not see each other, running dry is told. */
#include <pthread.h>

#include "adStack.h"
#include "check.h"

enum { THREADS = 8, DEPTH = 6 };

static void kinds(void)
{
  double d = 0.0, dn[3] = {1.0, -2.0, 3.5}, dm[3];
  float f = 0.0f, fn[2] = {0.5f, 4.0f}, fm[2];
  int i = 0, in[2] = {7, -8}, im[2], control[8];
  long l = 0, ln[2] = {1L << 40, -3}, lm[2];
  void *p = NULL;

  pushReal8(1.5);
  pushReal4(2.5f);
  pushInteger4(-3);
  pushInteger8(-(1L << 50));
  pushPointer8(&d);
  pushReal8Array(dn, 3);
  pushReal4Array(fn, 2);
  pushInteger4Array(in, 2);
  pushInteger8Array(ln, 2);
  pushReal8Array(dn, 0);
  pushControl1b(1);
  pushControl2b(3);
  pushControl3b(7);
  pushControl4b(15);
  pushControl5b(31);
  pushControl6b(63);
  pushControl7b(127);
  pushControl8b(255);

  popControl8b(&control[7]);
  popControl7b(&control[6]);
  popControl6b(&control[5]);
  popControl5b(&control[4]);
  popControl4b(&control[3]);
  popControl3b(&control[2]);
  popControl2b(&control[1]);
  popControl1b(&control[0]);
  for (i = 0; i < 8; ++i) CHECK(control[i] == (2 << i) - 1);
  popReal8Array(dm, 0);
  popInteger8Array(lm, 2);
  popInteger4Array(im, 2);
  popReal4Array(fm, 2);
  popReal8Array(dm, 3);
  CHECK(memcmp(lm, ln, sizeof ln) == 0);
  CHECK(memcmp(im, in, sizeof in) == 0);
  CHECK(memcmp(fm, fn, sizeof fn) == 0);
  CHECK(memcmp(dm, dn, sizeof dn) == 0);
  popPointer8(&p);
  popInteger8(&l);
  popInteger4(&i);
  popReal4(&f);
  CHECK(p == &d);
  popReal8(&d);
  CHECK(l == -(1L << 50));
  CHECK(i == -3);
  CHECK(f == 2.5f);
  CHECK(d == 1.5);
  CHECK(!adStack_failed());
}

/* over many blocks, with values across their borders; returns the number of wrong values */
static int deep(int n, double offset)
{
  int i, k, wrong = 0;
  double x, row[7];

  for (i = 0; i < n; ++i) {
    for (k = 0; k < 7; ++k) row[k] = offset + i + 0.1 * k;
    pushReal8Array(row, 7);
    pushControl1b(i & 1);
    pushReal8(offset - i);
  }
  for (i = n - 1; i >= 0; --i) {
    popReal8(&x);
    wrong += x != offset - i;
    popControl1b(&k);
    wrong += k != (i & 1);
    popReal8Array(row, 7);
    for (k = 0; k < 7; ++k) wrong += row[k] != offset + i + 0.1 * k;
  }
  return wrong + adStack_failed();
}

/* numbers first .. first + n - 1 come back from the top; the sweep pushes and pops of its own */
static int pop_numbers(int first, int n)
{
  int i, k, wrong = 0;

  for (i = first + n - 1; i >= first; --i) {
    wrong += deep(i % 3 == 0 ? 50 : 0, i);
    popInteger4(&k);
    wrong += k != i;
  }
  return wrong;
}

/* values with their tangents */
static void tangents(void)
{
  double x[2] = {1.0, 2.0}, xd[2] = {3.0, 4.0}, y[2], yd[2], z, zd;

  pushReal8_d(5.0, 6.0);
  pushReal8Array_d(x, xd, 2);
  popReal8Array_d(y, yd, 2);
  popReal8_d(&z, &zd);
  CHECK(memcmp(x, y, sizeof x) == 0);
  CHECK(memcmp(xd, yd, sizeof xd) == 0);
  CHECK(z == 5.0 && zd == 6.0);
}

/* a fixed-point sweep in a fixed-point sweep */
static int repeat(void)
{
  int i, j, wrong = 0;

  for (i = 0; i < 2000; ++i) pushInteger4(i);
  adStack_startRepeat();
  for (i = 0; i < 3; ++i) {
    if (i > 0) adStack_resetRepeat();
    wrong += pop_numbers(1500, 500);
    pushInteger4(-1); /* on top of what is kept, and in the inner one too */
    pushInteger4(-2);
    adStack_startRepeat();
    for (j = 0; j < 3; ++j) {
      if (j > 0) adStack_resetRepeat();
      wrong += pop_numbers(-2, 1);
      wrong += pop_numbers(-1, 1);
      wrong += pop_numbers(1000, 500);
    }
    adStack_endRepeat();
    wrong += pop_numbers(500, 500);
  }
  adStack_endRepeat();
  wrong += deep(300, 0.5);
  return wrong + pop_numbers(0, 500) + adStack_failed();
}

static void dry(void)
{
  double x = 1.0;
  int k = 1;
  void *p = &x;

  pushInteger4(5);
  popReal8(&x);
  CHECK(isnan(x));
  CHECK(adStack_failed());
  pushReal8(1.0);
  popReal8(&x);
  CHECK(isnan(x));
  popInteger4(&k);
  popPointer8(&p);
  CHECK(k == 0);
  CHECK(p == NULL);
  adStack_startRepeat();
  adStack_resetRepeat();
  adStack_endRepeat();
  adStack_clear();
  CHECK(!adStack_failed());
  pushReal8(2.0);
  popReal8(&x);
  CHECK(x == 2.0);
  adStack_endRepeat(); /* without start */
  adStack_resetRepeat();
  CHECK(deep(100, 0.0) == 0);
}

static void *run(void *argument)
{
  int *wrong = argument, i, depth = *wrong;

  *wrong = 0;
  for (i = 0; i < DEPTH; ++i) *wrong += deep(depth + 7 * i, depth) + repeat();
  return NULL;
}

int main(void)
{
  pthread_t thread[THREADS];
  int wrong[THREADS], i;

  kinds();
  tangents();
  CHECK(deep(20000, 3.0) == 0);
  CHECK(repeat() == 0);
  dry();
  for (i = 0; i < THREADS; ++i) {
    wrong[i] = 100 * i + 1;
    if (!CHECK(pthread_create(&thread[i], NULL, run, &wrong[i]) == 0)) return check_done();
  }
  for (i = 0; i < THREADS; ++i) {
    pthread_join(thread[i], NULL);
    CHECK(wrong[i] == 0);
  }
  return check_done();
}
