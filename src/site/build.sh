#!/usr/bin/env bash
# Builds the site of docs into target/site-docs; a broken link or anchor fails the build. It needs Python 3.9 or
# later, and installs the packages of requirements.txt into target/site-venv. Javadoc in target/reports/apidocs
# becomes part of the site; "--javadoc" builds it first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mkdir -p target

if [[ ${1:-} == --javadoc ]]; then
  mvn -B -q -DskipTests package
  # One run of javadoc cannot mix modules with and without module-info, so it gets a list of files.
  find src/{protocol,lang,kinematics,client,control,simulator,cell}/src/main/java mock-server/src/main/java \
    -name '*.java' ! -name module-info.java ! -path '*/internal/*' > target/javadoc-files
  jspecify=$(find ~/.m2/repository/org/jspecify -name 'jspecify-*.jar' 2>/dev/null | sort | tail -1)
  rm -rf target/reports/apidocs
  javadoc -quiet --ignore-source-errors -Xdoclint:none -encoding UTF-8 -windowtitle JOpenShowVar \
    -d target/reports/apidocs -classpath "src/cli/target/jopenshowvar.jar:$jspecify" @target/javadoc-files
fi

venv=target/site-venv
if ! cmp -s src/site/requirements.txt "$venv/requirements.txt"; then
  rm -rf "$venv"
  python3 -m venv "$venv"
  "$venv/bin/pip" -q --disable-pip-version-check install -r src/site/requirements.txt
  cp src/site/requirements.txt "$venv/"
fi
export NO_MKDOCS_2_WARNING=1 PYTHONDONTWRITEBYTECODE=1 # no announcements of Material, no files in src
exec "$venv/bin/mkdocs" build --strict --clean -f src/site/mkdocs.yml
