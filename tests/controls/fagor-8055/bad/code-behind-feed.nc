%0001-A,MX--,
;expected: 4:10 G1 stands behind F, and the control wants another order (error 0009)
N10 G71 G90 G94 F100 S500 M3
N20 F200 G1
N30 M30
