%AAAAAAAAAAAAAAAAAAAAA,MX--,
;expected: 1 with a name of up to 20 characters
N10 G71 G90 G94 F100
G1 X10
M30
