/**
 * `grade`: runs every program in every maze, or checks every program against a lesson, on all
 * cores.
 */
import { gradeArguments, gradeOptions } from "./arguments.ts";
import { exitCodes, runFields, type Command } from "./command.ts";

const help = `Usage:
  corridor grade --program FILE... --maze FILE... [--seconds N] [--until time|goal|bump]
                 [--csv | --why]
  corridor grade --challenge LESSON [--program FILE...] [--handins FILE]
                 [--unseen KIND:COLUMNSxROWS:COUNT:SEED] [--csv | --junit FILE]
                 [--require all|90%]

Runs every program in every maze, on all cores. Prints one line of JSON for each pair, in the order
of the files, and a summary.

With --challenge, checks every program against every task of a lesson, in all given and unseen mazes
of the task, and every completion code against its task. Prints one line of JSON for each program and
task, and a summary.

Options:
  --program FILE...   programs, such as submissions/*.json; with --challenge, also runs
  --maze FILE...      mazes, such as mazes/*.json
  --seconds N         maximum simulated time of a run, from 1/60 (one tick) to 86400; default: 300
  --until time        run for all seconds (default)
  --until goal        stop when the robot reaches a goal
  --until bump        stop at the first bump
  --why               add a diagnosis: what happened, the line that caused the failure, and changes
                      that fix it; null if the run did not fail
  --challenge LESSON  challenge document: its file, its link, or the text of the link after #
  --handins FILE      links of programs and completion codes, one on each line; - reads standard
                      input
  --unseen KIND:COLUMNSxROWS:COUNT:SEED
                      replace the unseen mazes of every task, such as tree:11x11:50:7; programs must
                      pass in all of them. KIND is tree, loops or rooms; sides are odd, from 5 to 33;
                      COUNT is from 1 to 1000, SEED from 0 to 999999
  --junit FILE        also write a JUnit report
  --require all       exit with code 1 unless all lines pass
  --require 90%       exit with code 1 unless this share of the lines passes
  --csv               print a CSV table without a summary
  --help              print this text

Fields of a line without --challenge, beside the files:
${runFields}

Fields of a line with --challenge:
  program     file, or the line of --handins, such as "line 3"
  task        number of the task, from 1
  passed      whether the program passes the task
  code        reason of the first failure, such as "bump"; null if the program passes
  maze, tick  place of the first failure: "maze 2" is a given maze, "tree 31 of seed 7" an unseen one
  lines       number of lines of the program, without "otherwise"; null for a drive
  seconds     simulated seconds in the slowest given maze; null unless the program passes in all
  unseen      count, number passed, and numbers of the failed unseen mazes; null if none were run
  problem     why a line of --handins is "unreadable", such as a code of another lesson; other lines
              do not have this field

${exitCodes("graded, even if the robot bumps or misses the goal", "--require is not met")}`;

export const command: Command = {
  help,
  run: async (args, { print, entry }) => {
    const options = gradeOptions(args);
    if (options.challenge === undefined) {
      const { gradeRuns } = await import("./grade-runs.ts");
      print(await gradeRuns(gradeArguments(options), entry));
      return 0;
    }
    const { gradeLesson } = await import("./lesson/grade-lesson.ts");
    const { lines, isMet } = await gradeLesson(options.challenge, options, entry);
    print(lines);
    return isMet ? 0 : 1;
  },
};
