#version 3.7;
global_settings { assumed_gamma 1 }
#macro Twice(A)
    A*2
#end
sphere { 0, Twice(1, 2) } //! error: Expected ')', float function 'float constant' found instead
sphere { 0, Twice() } //! error: Expected 1 parameters but only 0 found.
#macro Broken(A)
    sphere { 0, A wrong } //! error: No matching } in 'sphere', undeclared identifier 'wrong' found instead
#end
Broken(1)
Broken(2)
#macro 5() #end //! error: Expected 'undeclared identifier', float function 'float constant' found instead
#for (I, 1, 3, 0) #end //! error: #for loop increment must be non-zero.
#while (Undefined) sphere { 0, 1 } #end //! error: Expected 'numeric expression', undeclared identifier 'Undefined' found instead (did you mean 'defined'?)
#unknown //! error: Unknown directive '#unknown'
sphere { 0, 1 }
