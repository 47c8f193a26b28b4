import type { Message } from '../../messages/message.ts';
import type { SeenDome } from '../../pipelines/films/filmReader.ts';
import type { DomeMeans } from '../../render/lights/sky/domeMaps.ts';
import type { FilmEvent, FilmedDome } from '../../scene/film/seenFilm.ts';

/** Messages to the worker of a film: the film, then one event after the other. */
export type FilmMessage =
  | { readonly kind: 'open'; readonly dome: FilmedDome; readonly means?: DomeMeans | undefined }
  | { readonly kind: 'seen'; readonly event: FilmEvent };

/** A reply to each event. */
export type FilmReply =
  | { readonly kind: 'seen'; readonly seen: SeenDome }
  /** What the event before saw. */
  | { readonly kind: 'same' }
  | { readonly kind: 'failed'; readonly message: Message };
