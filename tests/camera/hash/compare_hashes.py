"""Runs programs that print hashes of pictures, each as it is and with the processor's newer
instructions hidden from the C library; all must print the same.

usage: compare_hashes.py PROGRAM PROGRAM..."""

import os
import subprocess
import sys

MASK = "glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable,-AVX_Usable"


def main():
    told = {}
    for program in sys.argv[1:]:
        for name, extra in (("plain", {}), ("masked", {"GLIBC_TUNABLES": MASK})):
            run = subprocess.run([program], check=True, capture_output=True, text=True, timeout=120,
                                 env={**os.environ, **extra})
            told[program, name] = run.stdout
            print(program, name, run.stdout, sep="\n")
    hashes = set(told.values())
    one_each = len(next(iter(hashes)).split("\n")) == 7 and len(set(
        line.split()[-1] for line in next(iter(hashes)).splitlines())) == 6
    sys.exit(0 if len(hashes) == 1 and one_each else 1)


if __name__ == "__main__":
    main()
