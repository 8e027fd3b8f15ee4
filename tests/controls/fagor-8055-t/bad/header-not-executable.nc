%TRY,M,
;expected: 1 the attributes M of the header are without X
N10 G71 G90 G94 F100
G1 X10
M30
