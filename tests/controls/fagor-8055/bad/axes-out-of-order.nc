%0001-A,MX--,
;expected: 4:15 X5.5 stands behind A, and the control wants another order (error 0048)
N10 G71 G90 G94 F100 S500 M3
N20 G1 A-1.85 X5.5 Z-0.008 B-0.09 C2.5 F100
N30 M30
