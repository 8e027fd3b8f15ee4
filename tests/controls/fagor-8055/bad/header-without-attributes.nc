%0001-TRY
;expected: 1 the first line is not %name,attributes
N10 G71 G90 G94 F100
G1 X10
M30
