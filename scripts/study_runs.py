"""Runs of a study: what is done stays done; what they gave, as one table."""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import subprocess

from stickslip import Results, ResultsError, StickslipError
from stickslip.results import PARAMETERS
from stickslip.running import LOG, STATES, command_of, environment, find_program, measure, variables_of
from study_file import ALWAYS, StudyError

RECORD = "study.json"  # in the directory of a run: written when it is over


def program():
    try:
        return find_program()
    except StickslipError as error:
        raise StudyError(str(error)) from error


class StudyRuns:
    def __init__(self, study, output):
        self.study = study
        self.output = pathlib.Path(output)
        self.version = ""  # of the program; ask_version() before runs

    def directory(self, run):
        return self.output / run.label

    def command(self, run, directory):
        return command_of(self.study.case, directory, {**self.study.fixed, **run.settings}, self.study.ranks, program())

    def fingerprint(self, run):
        text = self.study.parameters_of(run).text()
        return hashlib.sha256(text.encode()).hexdigest()

    def record(self, run):
        """What is known of a run that is over and of the present parameters, or None."""
        try:
            record = json.loads((self.directory(run) / RECORD).read_text())
        except (OSError, ValueError):
            return None
        return record if record.get("fingerprint") == self.fingerprint(run) else None

    def remaining(self, retry=False):
        """Runs that have not been done; with retry also those that failed."""
        def is_over(record):
            return record is not None and not (retry and record["state"] != "done")

        return [run for run in self.study.runs if not is_over(self.record(run))]

    def validate(self):
        """The program looks at each value of each parameter once; throws StudyError with what it says."""
        seen = set()
        for run in self.study.runs:
            new = set(run.settings.items()) - seen
            if not new and seen:
                continue
            seen |= new
            command = [program(), str(self.study.case), "--validate"]
            for name, value in {**self.study.fixed, **run.settings}.items():
                command += ["--set", f"{name}={value}"]
            result = subprocess.run(command, capture_output=True, text=True, env=environment())
            if result.returncode != 0:
                raise StudyError(f"run '{run.label}': {(result.stderr or result.stdout).strip()}")

    def ask_version(self):
        result = subprocess.run([program(), "--version"], capture_output=True, text=True, env=environment())
        self.version = result.stdout.strip()

    def execute(self, run):
        """One run from its beginning. Returns its state; a run that was killed leaves no record."""
        directory = self.directory(run)
        shutil.rmtree(directory, ignore_errors=True)
        directory.mkdir(parents=True)
        text = f"# {self.version}, {self.study.ranks} rank{'s' if self.study.ranks > 1 else ''}\n"
        (directory / PARAMETERS).write_text(text + self.study.parameters_of(run).text())
        usage = measure(self.command(run, directory.resolve()), directory / LOG, self.output,
                        variables_of(self.study.ranks), self.study.time_limit)
        state = "time limit" if usage.is_out_of_time else STATES.get(usage.exit_code, "killed")
        if state != "killed":
            record = {"state": state, "exit_code": usage.exit_code, "seconds": round(usage.seconds, 3), "program": self.version,
                      "fingerprint": self.fingerprint(run)}
            temporary = directory / (RECORD + ".part")
            temporary.write_text(json.dumps(record))
            temporary.rename(directory / RECORD)
        return state

    def execute_all(self, runs, jobs, say):
        """`jobs` runs at a time; say(run, state, number) after each."""
        count = 0
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            futures = {pool.submit(self.execute, run): run for run in runs}
            try:
                for future in concurrent.futures.as_completed(futures):
                    count += 1
                    say(futures[future], future.result(), count)
            except BaseException:
                for future in futures:
                    future.cancel()
                raise

    # ------------------------------------------------------------- collecting
    def row(self, run):
        """{column: value} of a run; empty texts where there is nothing."""
        study = self.study
        row = {study.columns[name]: run.values.get(name, "") for name in study.varied}
        row.update(dict.fromkeys(study.all_columns()[len(study.columns):], ""))
        record = self.record(run)
        row["state"] = record["state"] if record else "not run"
        if record is None:
            return row
        row["exit_code"], row["seconds"] = record["exit_code"], record["seconds"]
        try:
            result = Results(self.directory(run))
        except ResultsError:
            return row
        row["load_steps"] = result.n_steps
        for column in ALWAYS[3:-1]:
            row[column] = int(result.total(column))
        row["failed_newton_iterations"], row["cuts"] = int(result.n_failed_iterations), int(result.n_cuts)
        for collected in study.collected:
            row[collected.name] = self._collect(result, collected)
        return row

    def _collect(self, result, collected):
        table = result.table(collected.table)
        if not table.n_rows:
            return ""
        if collected.column not in table:
            raise StudyError(f"{self.study.path}: collect/{collected.name}: {collected.table} has no column "
                             f"'{collected.column}'; it has {', '.join(table)}.")
        return collected.of(table[collected.column]).item()

    def rows(self):
        return [self.row(run) for run in self.study.runs]
