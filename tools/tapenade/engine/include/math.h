/* what pycparser needs to see of <math.h> */
double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double sinh(double x);
double cosh(double x);
double tanh(double x);
double exp(double x);
double log(double x);
double sqrt(double x);
double pow(double x, double y);
double fabs(double x);
