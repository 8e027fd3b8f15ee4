%0001-A,MX--,
;expected: 4:28 G90 stands behind C, and the control wants another order (error 0004)
N10 G71 G90 G94 F100 S500 M3
N20 G81 X20 Z0 Q20 R-20 C5 G90
N30 M30
