/** A lesson that is not written as docs/guide/lessons.md says. For its author: the lessons are the program's own files. */
export class LessonError extends Error {
  constructor(file: string, line: number, problem: string) {
    super(`${file}:${line}: ${problem}`);
    this.name = 'LessonError';
  }
}
