#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = (1 + ); //! error: Expected 'numeric expression', ) found instead
#declare B = sqrt(-1); //! error: sqrt of negative number -1.000000
#declare C = ln(0); //! error: ln of negative number 0.000000
#declare D = <1, 2, 3>.transmit; //! error: Bad operands for period operator.
#declare E = vcross(x); //! error: Expected 'numeric expression', ) found instead
#declare F = str(1, 2); //! error: Expected 'numeric expression', ) found instead
#declare G = rand(0); //! error: Illegal random number generator.
#declare H = function { x + y.z } //! error: Expected '}', . found instead
#declare I = function { foo(x) } //! error: Expected 'operand', undeclared identifier 'foo' found instead
#declare J = <1, 2, 3, 4, 5, 6>; //! error: Expected '>': a vector has at most five components.
#declare K = atan2(0, 0); //! error: Domain error in atan2!
#declare L = substr("abc", 2, 5); //! error: Illegal parameters in substr.
#declare M = spline { } //! error: Spline must have at least one entry.
#declare N = concat("a", 1); //! error: Expected 'string expression', float function 'float constant' found instead
sphere { 0, 1 }
