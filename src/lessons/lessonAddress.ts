/** A step of a lesson, from 1; without a name, the list of lessons. */
export interface LessonPlace {
  readonly name?: string;
  readonly step: number;
}

/** `?lesson=NAME&step=N`, among other parameters; without a step it is the first. Undefined if no lesson is asked for. */
export function lessonPlaceOf(search: string | URLSearchParams): LessonPlace | undefined {
  const asked = new URLSearchParams(search);
  const name = asked.get('lesson');
  return name === null ? undefined : { name, step: Number(asked.get('step') ?? 1) };
}
