# nscc with scenes, the emulator and pictures. The build runs `make demo`, which tests the image.
#   docker build -t nscc .
#   docker run --rm -v "$PWD:/work" nscc demo photo.jpg
FROM python:3.13-slim

RUN apt-get update \
    && apt-get install --yes --no-install-recommends make \
    && rm -rf /var/lib/apt/lists/*

WORKDIR /opt/nscc
COPY . .
RUN make demo

ENV PATH="/opt/nscc/.venv/bin:$PATH"
WORKDIR /work
ENTRYPOINT ["nscc"]
CMD ["--help"]
