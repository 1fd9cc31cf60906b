/* The stack that adjoint code pushes values on in its forward sweep and pops them from in its backward
 * sweep: the calls that Tapenade writes, which the built-in engine uses too where nothing else is left.
 *
 * memory      each thread has a stack of its own; it grows by blocks, which are freed when the last
 *             value is popped, so that a balanced sweep leaves nothing behind
 * threads     safe: nothing is shared
 * status      where memory ran out pushes do nothing, pops give NaN and 0, and adStack_failed() is 1
 *             until adStack_clear()
 */
#ifndef MAGGI_ADSTACK_H
#define MAGGI_ADSTACK_H

/* names of our own, so that a program may have Tapenade's stack besides */
#define pushReal8           maggi_pushReal8
#define popReal8            maggi_popReal8
#define pushReal4           maggi_pushReal4
#define popReal4            maggi_popReal4
#define pushInteger4        maggi_pushInteger4
#define popInteger4         maggi_popInteger4
#define pushInteger8        maggi_pushInteger8
#define popInteger8         maggi_popInteger8
#define pushPointer8        maggi_pushPointer8
#define popPointer8         maggi_popPointer8
#define pushReal8Array      maggi_pushReal8Array
#define popReal8Array       maggi_popReal8Array
#define pushReal4Array      maggi_pushReal4Array
#define popReal4Array       maggi_popReal4Array
#define pushInteger4Array   maggi_pushInteger4Array
#define popInteger4Array    maggi_popInteger4Array
#define pushInteger8Array   maggi_pushInteger8Array
#define popInteger8Array    maggi_popInteger8Array
#define pushReal8_d         maggi_pushReal8_d
#define popReal8_d          maggi_popReal8_d
#define pushReal8Array_d    maggi_pushReal8Array_d
#define popReal8Array_d     maggi_popReal8Array_d
#define pushControl1b       maggi_pushControl
#define popControl1b        maggi_popControl
#define pushControl2b       maggi_pushControl
#define popControl2b        maggi_popControl
#define pushControl3b       maggi_pushControl
#define popControl3b        maggi_popControl
#define pushControl4b       maggi_pushControl
#define popControl4b        maggi_popControl
#define pushControl5b       maggi_pushControl
#define popControl5b        maggi_popControl
#define pushControl6b       maggi_pushControl
#define popControl6b        maggi_popControl
#define pushControl7b       maggi_pushControl
#define popControl7b        maggi_popControl
#define pushControl8b       maggi_pushControl
#define popControl8b        maggi_popControl
#define adStack_startRepeat maggi_adStack_startRepeat
#define adStack_resetRepeat maggi_adStack_resetRepeat
#define adStack_endRepeat   maggi_adStack_endRepeat
#define adStack_failed      maggi_adStack_failed
#define adStack_clear       maggi_adStack_clear

void pushReal8(double x);
void popReal8(double *x);
void pushReal4(float x);
void popReal4(float *x);
void pushInteger4(int x);
void popInteger4(int *x);
void pushInteger8(long x);
void popInteger8(long *x);
void pushPointer8(void *x);
void popPointer8(void **x);

/* n numbers, pushed and popped as a whole */
void pushReal8Array(double *x, int n);
void popReal8Array(double *x, int n);
void pushReal4Array(float *x, int n);
void popReal4Array(float *x, int n);
void pushInteger4Array(int *x, int n);
void popInteger4Array(int *x, int n);
void pushInteger8Array(long *x, int n);
void popInteger8Array(long *x, int n);

/* in the tangent of an adjoint: a value and its tangent */
void pushReal8_d(double x, double xd);
void popReal8_d(double *x, double *xd);
void pushReal8Array_d(double *x, double *xd, int n);
void popReal8Array_d(double *x, double *xd, int n);

/* which way a branch went: 0 to 2^k - 1, k = 1 to 8 */
void pushControl1b(int x);
void popControl1b(int *x);

/* What is on the stack at startRepeat is kept when it is popped; resetRepeat goes back to it, and
 * endRepeat ends that.  May be nested; pushes in between are popped before what was kept. */
void adStack_startRepeat(void);
void adStack_resetRepeat(void);
void adStack_endRepeat(void);

int adStack_failed(void); /* whether the stack of this thread ran out of memory */
void adStack_clear(void); /* empties it, frees its memory, forgets the failure */

#endif
