%0001-A,MX--,
;expected: 4:16 Z10 stands behind F, and the control wants another order (error 0002)
N10 G71 G90 G94 F100 S500 M3
N20 G1 X5 F0.2 Z10
N30 M30
