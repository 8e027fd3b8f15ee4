%0001-A,MX--,
;expected: 4:12 G90 stands behind X, and the control wants another order (error 0004)
N10 G71 G90 G94 F100 S500 M3
N20 G1 X10 G90
N30 M30
