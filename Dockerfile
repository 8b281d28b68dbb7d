# The course built in Debian 12, with the packages of the one list. For whoever has Docker and another system, and for
# grading where nothing may be installed:
#
#     docker build -t relief .
#     docker run --rm relief list
#     docker run --rm -v "$PWD:/work" relief grade submissions/* -o marks --trust
#
# --trust: a container seldom may make the namespaces that keep a submission from the rest; it is the container that does.
# `--build-arg FOR=slides` has what slides need as well, `--build-arg FOR=ci` all that the tests need.
FROM debian:12
ARG FOR=build
COPY framework/cmake/packages.txt /tmp/packages.txt
RUN apt-get update \
 && apt-get install -y --no-install-recommends \
    $(awk -v kind="$FOR" '!/^#/ && ($1 == "build" || $1 == kind || kind == "ci") { print $2 }' /tmp/packages.txt) \
 && rm -rf /var/lib/apt/lists/*
COPY . /course
RUN /course/relief build
WORKDIR /work
ENTRYPOINT ["/course/relief"]
CMD ["--help"]
