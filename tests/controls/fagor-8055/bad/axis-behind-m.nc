%0001-A,MX--,
;expected: 4:11 X10 stands behind M, and the control wants another order (error 0002)
N10 G71 G90 G94 F100 S500 M3
N20 G1 M8 X10
N30 M30
