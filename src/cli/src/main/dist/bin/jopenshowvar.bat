@echo off
rem Starts the command line. It needs Java 17 or later: JAVA_HOME if that is set, else java in PATH.
setlocal DisableDelayedExpansion

set "JAR=%~dp0..\lib\jopenshowvar.jar"
if not exist "%JAR%" (
  echo jopenshowvar: "%JAR%" is missing>&2
  exit /b 127
)

rem Else cmd would take a java.exe in the current folder first.
set "NoDefaultCurrentDirectoryInExePath=1"
if not defined JAVA_HOME goto find
if not exist "%JAVA_HOME%\bin\java.exe" (
  echo jopenshowvar: JAVA_HOME is "%JAVA_HOME%", where there is no bin\java.exe>&2
  exit /b 127
)
rem In PATH it needs no quotes below, which for /f cannot handle.
set "PATH=%JAVA_HOME%\bin;%PATH%"

:find
where /q java.exe
if errorlevel 1 (
  echo jopenshowvar: needs Java 17 or later; there is no java in PATH, and JAVA_HOME is not set>&2
  exit /b 127
)
set "VERSION="
for /f "tokens=3" %%v in ('java.exe -version 2^>^&1 ^| findstr /c:" version "') do set "VERSION=%%~v"
set "MAJOR=0"
for /f "delims=.-+_" %%m in ("%VERSION%") do set "MAJOR=%%m"
if %MAJOR% LSS 17 (
  echo jopenshowvar: needs Java 17 or later; java is "%VERSION%">&2
  exit /b 127
)

rem Commands that end at once do not wait for the better compiler and the bigger collector.
set "OPTIONS=-XX:TieredStopAtLevel=1"
if not defined JDK_JAVA_OPTIONS if not defined JAVA_TOOL_OPTIONS set "OPTIONS=%OPTIONS% -XX:+UseSerialGC"
for %%c in (bench drive experiment mock plot record run shell watch) do if "%~1"=="%%c" set "OPTIONS="

java.exe %OPTIONS% -jar "%JAR%" %*
exit /b %ERRORLEVEL%
