;expected: 4 block without words
%0001-A,MX--,
N10 G71 G90 G94 F100

G1 X10
M30
