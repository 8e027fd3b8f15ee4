%0001-A,MX--,
;expected: 4:11 X5 stands behind Z, and the control wants another order (error 0048)
N10 G71 G90 G94 F100 S500 M3
N20 G0 Z1 X5
N30 M30
