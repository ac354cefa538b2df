; 8 slots, 12750 us of light a frame
; 102 words stored in 9 kernels; 102 executed a frame in 9 launches, 76.8 us
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
| where_reads_flag = false                   # may WHERE read FLAG, which it also writes? (not public)
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
| launch_us = 7.0                            # overhead of one kernel launch (not public)
| wait_us = 1.0                              # the frame loop's own time at a boundary (not public)
| readout_us = 16700.0                       # reading one analog register, or all taps, of the whole array out (not public)
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
| in_step_e = "auto"                         # electrons a step of IN; "auto": register_max_e / 127 (not public)
| in_settle_us = 5.0                         # time from setting IN to the first word that reads it (not public)
|
| [neighbours]                               # how words reach the pixels to the north, east, south and west
| sees_neighbours = true                     # do words reach the NEWS, and the digital registers, of neighbours? (not public)
| directed_sources = 2                       # most analog sources of a word that writes or reads a neighbour's NEWS (not public)
| directed_halving = false                   # may a bus2 word read a neighbour's NEWS? (not public)
| news_read_keeps = true                     # does NEWS keep its value when neighbours read it? (not public)
.note class "general"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # A rule that is none of the paper's classes, on unequal slots: open up to a longest slot, but for
| # one that is left out, such as the slot in which a neighbour's lamp flashes.
| nsl 1
|
| frame slots [50us, 100us, 200us, 400us, 800us, 1.6ms, 3.2ms, 6.4ms]
|
| code longest : 0..N - 1
| code skip : 0..N - 1
| open when n <= longest and n != skip
|
| pixels longest = (x + y) % N
| pixels skip = (3 * x + 5 * y) % N

.wait 50us 100us 200us 400us 800us 1600us 3200us 6400us

.kernel k0                               ; 8 words, 8.6 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 9 words, 8.3 us; launched at 1
    NOR R0, R5, R6
    WHERE R0
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R4, R6
    NOR R10, R3, R4, R6
    WHERE R0, R10
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k2                               ; 10 words, 8.4 us; launched at 2
    NOR R0, R2, R5, R7
    NOR R10, R1, R5, R7
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R5, R6
    NOR R10, R2, R5, R6
    WHERE R0, R10
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k3                               ; 10 words, 8.4 us; launched at 3
    NOR R0, R1, R2, R4, R6
    NOR R10, R3, R7, R8, R12
    NOR R11, R3, R4, R7, R8
    WHERE R0, R10, R11
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R5, R7
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k4                               ; 9 words, 8.3 us; launched at 4
    NOR R0, R1, R3, R5, R6
    NOR R10, R2, R4, R7, R8
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R3, R4, R7, R8
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k5                               ; 10 words, 8.4 us; launched at 5
    NOR R0, R1, R3, R4, R6
    NOR R10, R1, R2, R5, R7
    NOR R11, R2, R9
    WHERE R0, R10, R11
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R2, R4, R7, R8, R12
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k6                               ; 10 words, 8.4 us; launched at 6
    NOR R0, R1, R2, R5, R6
    NOR R10, R3, R4, R7, R8, R12
    NOR R11, R1, R3, R9
    WHERE R0, R10, R11
    bus NEWS, A, PIX
    bus A, B, NEWS
    NOR R0, R1, R2, R9
    WHERE R0
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k7                               ; 9 words, 8.1 us; launched at 7
    NOR R0, R3, R4, R6, R12
    NOR R10, R1, R3, R5, R7
    NOR R11, R2, R4, R7, R8, R12
    OR R0, R0, R10, R11
    NOR R10, R3, R9, R12
    WHERE R0, R10
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k8                               ; 27 words, 9.9 us; launched at 8
    NOR R0, R2, R5, R6, R12
    NOR R10, R1, R3, R4, R7, R8
    NOR R11, R1, R2, R9
    WHERE R0, R10, R11
    bus NEWS, A, PIX
    bus A, B, NEWS
    SET R0
    REFRESH R12
    REFRESH R1
    REFRESH R2
    REFRESH R3
    REFRESH R4
    REFRESH R5
    REFRESH R6
    REFRESH R7
    REFRESH R8
    REFRESH R9

.slot 0 k0
.slot 1 k1
.slot 2 k2
.slot 3 k3
.slot 4 k4
.slot 5 k5
.slot 6 k6
.slot 7 k7
.slot 8 k8

.bucket frame
.readout A frame 1

.load R12 R1 R2 R3 R4 R5 R6 R7 R8 R9
.fields longest skip
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0101010101000 never             ; 0
.shutter 0001010101001 1..2              ; 1
.shutter 0010010101001 1..4              ; 2
.shutter 0110010101000 1..6              ; 3
.shutter 0110100101000 0                 ; 4
.shutter 0010100101001 0,2..3            ; 5
.shutter 0001100101001 0,2..5            ; 6
.shutter 0101100101000 0,2..7            ; 7
.shutter 0101101001000 0..1              ; 8
.shutter 0001101001001 0..1,3..4         ; 9
.shutter 0010101001001 0..1,3..6         ; 10
.shutter 0110101001000 0..2              ; 11
.shutter 0110011001000 0..2,4..5         ; 12
.shutter 0010011001001 0..2,4..7         ; 13
.shutter 0001011001001 0..3              ; 14
.shutter 0101011001000 0..3,5..6         ; 15
.shutter 0101011010000 0..4              ; 16
.shutter 0001011010001 0..4,6..7         ; 17
.shutter 0010011010001 0..5              ; 18
.shutter 0110011010000 0..6              ; 19
; a line a code: its shutter, then its fields
.code 0 0 0
.code 4 0 2
.code 4 0 4
.code 4 0 6
.code 4 1 1
.code 8 1 3
.code 8 1 5
.code 8 1 7
.code 1 2 0
.code 8 2 2
.code 11 2 4
.code 11 2 6
.code 5 3 1
.code 11 3 3
.code 14 3 5
.code 14 3 7
.code 2 4 0
.code 9 4 2
.code 14 4 4
.code 16 4 6
.code 6 5 1
.code 12 5 3
.code 16 5 5
.code 18 5 7
.code 3 6 0
.code 10 6 2
.code 15 6 4
.code 18 6 6
.code 7 7 1
.code 13 7 3
.code 17 7 5
.code 19 7 7

; the code of every pixel
.pixels tile 8 8
| 0 5 11 12 18 23 25 30
| 6 8 13 19 20 26 31 1
| 9 14 16 21 27 28 2 7
| 15 17 22 24 29 3 4 10
| 18 23 25 30 0 5 11 12
| 20 26 31 1 6 8 13 19
| 27 28 2 7 9 14 16 21
| 29 3 4 10 15 17 22 24
