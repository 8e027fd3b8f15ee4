%0001-A,MX--,
;expected: 4:8 T1 stands behind D, and the control wants another order (error 0003)
N10 G71 G90 G94 F100 S500 M3
N20 D1 T1
N30 M30
