; 64 slots, 16000 us of light a frame
; 13 words stored in 3 kernels; 13 executed a frame in 3 launches, 5.6 us
.target
| # A target of nscc: what the compiler, the checker and the emulator know of a chip.
| # Keys marked (not public) are this project's defaults; they may be left out.
| name = "scamp5"
| kind = "scamp"
| description = "SCAMP-5: global PIX reset, non-destructive read"
|
| [array]                                    # the pixels
| rows = 256                                 # pixels from top to bottom
| cols = 256                                 # pixels from left to right
|
| [registers]                                # of one pixel
| analog = ["A", "B", "C", "D", "E", "F", "NEWS"] # analog registers of one pixel
| analog_scratch = "NEWS"                    # register that every analog sequence overwrites
| # one-bit registers of one pixel
| digital = ["R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9", "R10", "R11", "R12"]
| mask = "R0"                                # a word changes `masked` only in pixels where this register is 1
| masked = "R12"                             # the register that `mask` guards; both are "none" on a chip without this
|
| [behaviour]                                # these values are not public: each key has a default
| reset_honours_flag = "no"                  # does rpix reset only where FLAG is 1? "no", "yes" or "unknown" (not public)
| where_reads_flag = true                    # may WHERE read FLAG, which it also writes? (not public)
| where_obeys_flag = false                   # does the analog `where` itself act only where FLAG is 1? (not public)
| or_sources = "any"                         # most sources of an OR or NOR word: "any" or a number (not public)
| where_sources = "any"                      # most sources of a WHERE word: "any" or a number (not public)
|
| [store]
| words = 1024                               # largest number of ICWs in all stored kernels
| tables_count = true                        # do constant kernel tables count against the store? (not public)
|
| [time]
| analog_word_us = 0.2                       # one analog word (not public)
| digital_word_us = 0.1                      # one digital word (not public)
| launch_us = 1.0                            # overhead of one kernel launch (not public)
| wait_us = 1.0                              # the frame loop's own time at a boundary (not public)
| readout_us = 16701.0                       # reading one analog register, or all taps, of the whole array out (not public)
| digital_retention_us = 1500000.0           # time for which a digital register keeps an unwritten bit
|
| [range]
| full_well_e = 30000.0                      # electrons that PIX, or a tap, can hold (not public)
| register_min_e = -30000.0                  # least value of an analog register, below 0 (not public)
| register_max_e = 30000.0                   # largest value of an analog register, above 0 (not public)
| adc_bits = 8                               # bits of the readout
| adc_offset_lsb = 0.0                       # offset added to the converter code of an exposure of 0 (not public)
| readout = "spread"                         # codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); full, the upper half, for the converter is symmetric around 0; half, 0 to the middle (not public)
|
| [in]                                       # the global value IN that every pixel can compare with; set between kernels
| in_low = -127                              # least value of IN, in steps (not public)
| in_high = 126                              # largest value of IN, in steps (not public)
| in_step_e = 1000.0                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "general"
.note codes "open"
.note level "0"
.note lowering "latch"

.source
| # High dynamic range and local contrast: the long exposure where it is not full, else the short one.
| nsl 3
| frame 64 slots of 250us
| bucket short open when n < 16
| bucket long open when true
|
| kernel around = [[1, 2, 1], [2, 4, 2], [1, 2, 1]] / 16
| plane full = long > 90%
| image hdr = short if full else long / 4
| image contrast = hdr - around(hdr)
| read contrast, full

.wait 250us x64

.kernel k0                               ; 9 words, 2.8 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    bus B, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus C, NEWS

.kernel k1                               ; 2 words, 1.4 us; launched at 16
    bus NEWS, PIX
    bus A, C, NEWS

.kernel k2                               ; 2 words, 1.4 us; launched at 64
    bus NEWS, PIX
    bus B, C, NEWS

.slot 0 k0
.slot 16 k1
.slot 64 k2

.bucket short long
.readout A short 1
.readout B long 1

; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0000000000000 0..15 0..63       ; 0
; a line a code: its shutter, then its fields
.code 0

; images and planes: these words follow the last slot's
; kernel 0, IN at -27
;     all
;     where B, IN
;     MOV R1, FLAG
;     all
;     bus2 C, NEWS, B
;     bus2 B, NEWS, C
;     bus D, B
;     WHERE R1
;     bus D, A
;     all
;     bus XW, D
;     bus2 A, E, NEWS, D
;     bus2 NEWS, F, A, D
;     bus A, F, XW
;     bus XN, A
;     bus2 E, F, A, NEWS
;     bus2 NEWS, F, A, E
;     bus E, F, XN
;     bus NEWS, D
;     bus F, NEWS, E
;     bus D, F
; D holds contrast
; R1 holds full
.pictures
| eyJjb3N0cyI6W1siZnVsbCIsMywwLjAsMC4wXSxbImhkciIsNiwxLjAsMS41XSxbImNvbnRyYXN0IiwxMSwxLjAsMy4yNDgx
| OTY2MTUwNDY1NzA2XV0sIml0ZW1zIjpbWyJmdWxsIixbIkFib3ZlIixbIlNvdXJjZSIsImxvbmciXSwyN11dLFsiaGRyIixb
| IkNob3NlbiIsWyJCaXQiLCJmdWxsIl0sWyJTb3VyY2UiLCJzaG9ydCJdLFsiU3VtIixbMSw0LFsiU291cmNlIiwibG9uZyJd
| XV1dXSxbImNvbnRyYXN0IixbIlN1bSIsWzEsMSxbIlNvdXJjZSIsImhkciJdXSxbLTEsMSxbIkZpbHRlcmVkIiwiYXJvdW5k
| IixbIlNvdXJjZSIsImhkciJdXV1dXV0sImtlcm5lbHMiOltbImFyb3VuZCIsW1sxLDIsMV0sWzIsNCwyXSxbMSwyLDFdXSwx
| Nl1dLCJsYXVuY2hlcyI6W1swLC0yN11dLCJsaW1pdHNfZSI6eyJsb25nIjozMDAwMC4wLCJzaG9ydCI6MzAwMDAuMH0sIm91
| dHNpZGUiOm51bGwsInJlYWRzIjpbImNvbnRyYXN0IiwiZnVsbCJdLCJyZWdpc3RlcnMiOnsiY29udHJhc3QiOiJEIiwiZnVs
| bCI6IlIxIn0sInJlcG9ydHMiOltdLCJ3b3JkcyI6W1tbMjA0OCw2OTYzMiwxMzEwNzIsMjA0ODAwLDI2MjE0NF0sWzMyLDY1
| NjE2LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTI0Mzg0LDY1NTM2LDEzNTE2OCwyNTM5NTIsMjYyMTQ0XSxbMjA0OCw2OTYz
| MiwxMzEwNzIsMjA0ODAwLDI2MjE0NF0sWzMzNzkyLDY1OTg1LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTc0MDgsNjU5ODUs
| MTMxMDcyLDE5NjYwOCwyNjIxNDRdLFswLDY2MTE0LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbNTI2MzM2LDY1NTUyLDEzMTA3
| MywyMDQ4MDAsMjYyMTQ0XSxbMCw2NjA4MiwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzIwNDgsNjk2MzIsMTMxMDcyLDIwNDgw
| MCwyNjIxNDRdLFswLDc0NDk3LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbOTIxNiw2NzM2NCwxMzEwNzIsMTk2NjA4LDI2MjE0
| NF0sWzEwMjQsNjgzOTMsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFs4MTkyLDc2MDY0LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxb
| MTI4LDY1ODI1LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTAyNCw2ODkwOCwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzEwMjQs
| Njg5MDUsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFsxMjgsNjg4NjgsMTMxMDcyLDE5NjYwOCwyNjIxNDRdLFsxMDI0LDY2MzA1
| LDEzMTA3MiwxOTY2MDgsMjYyMTQ0XSxbMTAyNCw2ODg3MiwxMzEwNzIsMTk2NjA4LDI2MjE0NF0sWzAsNjgwOTgsMTMxMDcy
| LDE5NjYwOCwyNjIxNDRdXV19

; the code of every pixel
.pixels tile 1 1
| 0
