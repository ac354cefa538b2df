// What programs for the devkit have in common: `nscc.emit.cpp.text.part` takes a part, from the
// line behind its `//:` on, and puts values in place of names between `@`.

//: run
// Runs a constant table, be scamp5_kernel(table, n) a function that runs it or an object that runs
// when it is called.
struct Run {};
template <class Kernel>
auto operator,(Kernel &&kernel, Run) -> decltype(kernel()) {
    return kernel();
}

//: step
struct Step {
    uint32_t wait_us;               // for the rest of the slots before
    uint16_t kernel;                // then this one of `kernels` runs,
    uint16_t times;                 // so many times over
};

//: expose
void expose() {
    for (const Step &step : schedule) {
        for (uint16_t i = 0; i < step.times; ++i) {
            if (step.wait_us) {
                vs_wait(step.wait_us);
            }
            kernels[step.kernel]();
        }
    }
}

//: fading
// Digital memory fades when it is not written for a while: all codes are written back after each
// plane, and again and again during what takes long.

//: match
// All pixels whose address is (row, col) but for the bits set in the masks.
struct Match {
    uint8_t row, col, row_mask, col_mask;
};

//: among
template <int count>
bool among(const Match (&matches)[count], int row, int col) {
    for (const Match &match : matches) {
        if (((row ^ match.row) & ~match.row_mask) == 0 &&
            ((col ^ match.col) & ~match.col_mask) == 0) {
            return true;
        }
    }
    return false;
}

//: images
// Draws an image onto a cleared plane. Column 0 of the image is its left one, column 0 of the array
// the right one.
template <class Plane>
void draw(const vs_dotmat &image, const Plane &plane) {
    const uint8_t *bits = static_cast<const uint8_t *>(image.get_buffer());
    scamp5_draw_begin(plane);
    for (int row = 0; row < rows; ++row) {
        for (int x = 0; x < cols; ++x) {
            if (bits[(row * @width@ + x) / 8] >> x % 8 & 1) {
                scamp5_draw_pixel(row, cols - 1 - x);
            }
        }
        if (row % 16 == 15) {
            refresh_codes();
        }
    }
    scamp5_draw_end();
}

// Asks the host for an image until it is there, with the right size: a request that is not answered
// in time, or was not taken, is made again.
template <class Plane>
void load_image(const char *file, const Plane &plane) {
    bool drawn = false;
    while (!drawn) {
        bool answered = false;
        vs_gui_request_image(file, 1, [&](const vs_dotmat &image, int status) {
            answered = true;
            if (status >= 0 && image.get_width() == @width@ &&
                image.get_height() == rows) {
                draw(image, plane);
                drawn = true;
            }
        });
        for (int turn = 0; turn < 20 && !answered; ++turn) {
            vs_frame_loop_control();
            refresh_codes();
        }
    }
}

//: drawn
    scamp5_draw_begin(@register@);
    for (int row = 0; row < rows; ++row) {
        for (int col = 0; col < cols; ++col) {
            if (@inverted@among(@codes@, row, col)) {
                scamp5_draw_pixel(row, col);
            }
        }
        if (row % 16 == 15) {
            refresh_codes();
        }
    }
    scamp5_draw_end();

//: gathered
    for (const Match &match : @codes@) {
        scamp5_load_pattern(@scratch@, match.row, match.col, match.row_mask,
                            match.col_mask);
@add@
    }

//: record
    // A kernel is recorded when it first runs, which takes time: here, where none is lost.
    for (void (*kernel)() : kernels) {
        kernel();
    }

//: awaiting
    // While images are awaited, codes are refreshed at this rate.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, @rate@);

//: frames
    // Faster than frames can be, so that none waits for the next: codes fade meanwhile.
    vs_configure_frame_trigger(VS_FRAME_TRIGGER_CONST_LOOP, @rate@);
    while (true) {
        vs_frame_loop_control();
        expose();
        // Pixels that FLAG leaves out would be left out of readout.
@prepare@
