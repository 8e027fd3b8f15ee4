;expected: 2 the attributes M of the header are without X
%TRY,M,
N10 G71 G90 G94 F100
G1 X10
M30
