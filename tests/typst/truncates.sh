#!/bin/sh
# A typst that ends well and leaves half a PDF.
printf '%%PDF-1.7\nhalf a' > report.pdf
