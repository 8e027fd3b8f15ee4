;expected: 2 the first line is not %name,attributes
%0001-TRY
N10 G71 G90 G94 F100
G1 X10
M30
