# The course, built in Debian 12 with the packages of framework/cmake/packages.txt. For users of Docker on other
# systems, and for grading on machines where nothing may be installed:
#
#     docker build -t relief .
#     docker run --rm relief list
#     docker run --rm -v "$PWD:/work" relief grade submissions/* -o marks --trust
#
# --trust: a container can seldom create the namespaces that isolate a submission. The container itself isolates it.
# Without --trust: docker run --security-opt seccomp=unconfined --security-opt apparmor=unconfined (labs/staff/README.md).
# `--build-arg FOR="build pictures staff slides"` adds the packages for slides.
FROM debian:12
ARG FOR="build pictures staff"
COPY framework/cmake/packages.txt /tmp/packages.txt
RUN apt-get update \
 && apt-get install -y --no-install-recommends \
    $(awk -v purposes=" $FOR " '!/^#/ && index(purposes, " " $1 " ") { print $2 }' /tmp/packages.txt) \
 && rm -rf /var/lib/apt/lists/*
COPY . /course
RUN /course/relief build
WORKDIR /work
ENTRYPOINT ["/course/relief"]
CMD ["--help"]
