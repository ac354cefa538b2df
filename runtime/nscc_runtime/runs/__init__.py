"""What the runtime does for kinds of programs; `nscc_runtime.run_kinds` lists them."""
