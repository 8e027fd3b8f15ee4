%0001-A,MX--,
;expected: 4:13 X10 stands behind F, and the control wants another order (error 0002)
N10 G71 G90 G94 F100 S500 M3
N20 G1 F200 X10
N30 M30
