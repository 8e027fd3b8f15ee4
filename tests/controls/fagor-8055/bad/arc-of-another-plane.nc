%0001-A,MX--,
;expected: 4:18 J does not belong to the plane G18
N10 G71 G90 G18
N20 G2 X10 Y0 I5 J0 F100
N30 M30
