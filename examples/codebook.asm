; 32 slots, 32000 us of light a frame
; 22 words stored in 5 kernels; 78 executed a frame in 33 launches, 35.04 us
.target
| # A target of nscc: what the compiler, the checker and the emulator know of a chip.
| # Keys marked (not public) are this project's defaults; they may be left out.
| name = "scamp5"
| kind = "scamp"
| description = "SCAMP-5: global PIX reset, non-destructive read"
|
| [array]                                    # the pixels
| rows = 1                                   # pixels from top to bottom
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
| analog_word_us = 0.02                      # one analog word (not public)
| digital_word_us = 0.1                      # one digital word (not public)
| launch_us = 1.0                            # overhead of one kernel launch (not public)
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
.note class "codebook"
.note codes "fixed"
.note level "0"
.note lowering "edges"

.source
| # Any shutters at all, listed as digits: a pixel names a row of the book. Four rows are two bits a
| # pixel however long the rows are, where free bits would need a register for each slot.
| # These are Walsh functions: with 0 read as -1, no row correlates with another.
| nsl 1
|
| frame 32 slots of 1ms
|
| shutters book [
|     1111_1111_1111_1111_1111_1111_1111_1111,
|     1010_1010_1010_1010_1010_1010_1010_1010,
|     1100_1100_1100_1100_1100_1100_1100_1100,
|     1001_1001_1001_1001_1001_1001_1001_1001,
| ]
| code id : row of book
| open when book[id]
|
| pixels id = tile [[0, 1],
|                   [2, 3]]

.wait 1000us x32

.kernel k0                               ; 8 words, 1.16 us; launched at 0
    all
    bus NEWS
    bus A, NEWS
    rpix
    rpix
    nop
    bus NEWS, PIX
    bus B, NEWS

.kernel k1                               ; 3 words, 1.14 us; launched at 1
    WHERE R1
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k2                               ; 2 words, 1.04 us; launched at 2..30/2
    bus NEWS, A, B
    bus A, NEWS, PIX

.kernel k3                               ; 2 words, 1.04 us; launched at 3..31/2
    bus NEWS, A, PIX
    bus A, B, NEWS

.kernel k4                               ; 7 words, 1.54 us; launched at 32
    WHERE R2
    bus NEWS, A, PIX
    bus A, B, NEWS
    REFRESH R1
    REFRESH R2

.slot 0 k0
.slot 1 k1
.slot 2..30/2 k2
.slot 3..31/2 k3
.slot 32 k4

.bucket frame
.readout A frame 1

.load R1 R2
.fields id
; a line a shutter: R0..R12 at the start of a frame, then the open slots of each bucket
.shutter 0100000000000 0..30/2           ; 0
.shutter 0010000000000 0..31             ; 1
; a line a code: its shutter, then its fields
.code 1 0
.code 0 1

; the code of every pixel
.pixels tile 1 2
| 0 1
