%0001-A,MX--,
;expected: 4 block without words
N10 G71 G90 G94 F100

G1 X10
M30
