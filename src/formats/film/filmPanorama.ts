import { msg } from '../../messages/message.ts';
import { type FilmEvent, type FilmedDome, framesSeen, onlyFrameSeen } from '../../scene/film/seenFilm.ts';
import type { DomePicture, Texture } from '../../scene/types.ts';
import { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { unfoldedPicture } from '../panorama/unfoldPicture.ts';
import type { FilmFrames, OpenFilmFrames } from './filmFrames.ts';

/**
 * What events see of a dome's film; one picture is made at a time.
 * @example
 * import { domeMaps, type SceneRenderer } from 'slowlight/render';
 * import { filmedDome, type Scene } from 'slowlight/scene';
 * // With a scene that was read of a film, and what decodes films here; then the renderer draws its next picture.
 * async function showFilm(scene: Scene, openFrames: OpenFilmFrames, renderer: SceneRenderer, t: number) {
 *   const film = new FilmPanorama(filmedDome(scene)!, openFrames);
 *   const seen = await film.seenAt({ t, position: [0, 0, 0], speedOfLight: 10 });
 *   renderer.showDome(domeMaps(seen, 'none'));
 *   film.close();
 * }
 */
export class FilmPanorama {
  private readonly dome: FilmedDome;
  private readonly frames: FilmFrames;
  private readonly cacheBytes: number;
  /** By index; the least recently used first. */
  private readonly cache = new Map<number, Uint8Array>();
  private last: { readonly key: string; readonly picture: DomePicture } | undefined;

  /** `cacheBytes`: memory for frames that may be seen again. */
  constructor(dome: FilmedDome, open: OpenFilmFrames, cacheBytes = 2 ** 28) {
    this.cacheBytes = cacheBytes;
    this.dome = dome;
    this.frames = open(dome.film.track);
  }

  /** The dome's picture as it is seen at an event; the same object for events that see the same. Rejects with a MessageError where a frame cannot be decoded. */
  async seenAt(event: FilmEvent): Promise<DomePicture> {
    const { film, texture } = this.dome;
    const only = onlyFrameSeen(film, event);
    const key = only === undefined ? JSON.stringify(event) : `${only}`;
    if (this.last?.key === key) return this.last.picture;
    const data = only === undefined ? await this.severalFrames(event) : await this.frame(only);
    // What is cached must not be given away.
    const picture: DomePicture = { ...(texture as Texture), data: only === undefined ? data : data.slice() };
    this.last = { key, picture };
    return picture;
  }

  /** Gives the decoder and its frames back. */
  close(): void {
    this.frames.close();
    this.cache.clear();
  }

  private async severalFrames(event: FilmEvent): Promise<Uint8Array> {
    const { texture } = this.dome;
    const { frames, texels, first } = framesSeen(this.dome, event, texture);
    const out = new Uint32Array(texture.width * texture.height);
    for (const [i, index] of frames.entries()) {
      const from = await this.frame(index);
      const colors = new Uint32Array(from.buffer, from.byteOffset, out.length);
      for (let k = first[i]; k < first[i + 1]; k++) out[texels[k]] = colors[texels[k]];
    }
    return new Uint8Array(out.buffer);
  }

  /** A frame by latitude and longitude: RGBA, at an offset of whole pixels. */
  private async frame(index: number): Promise<Uint8Array> {
    const found = this.cache.get(index) ?? (await this.decoded(index));
    this.cache.delete(index);
    this.cache.set(index, found);
    for (const oldest of this.cache.keys()) {
      if (this.cache.size <= 1 || this.cache.size * found.length <= this.cacheBytes) break;
      this.cache.delete(oldest);
    }
    return found;
  }

  private async decoded(index: number): Promise<Uint8Array> {
    const { film, texture } = this.dome;
    const { name } = film.track.file;
    const decoded = { ...(await this.frames.frame(index)), colorSpace: 'srgb' } as const;
    const picture = unfoldedPicture(decoded, film.layout, name, new DiagnosticLog(name));
    if (picture?.width !== texture.width || picture.height !== texture.height)
      throw inputError('film.undecodable', name, msg`its frame ${index} is no panorama of the size of the first`);
    const { data } = picture;
    return data.byteOffset % 4 === 0 ? (data as Uint8Array) : (data as Uint8Array).slice();
  }
}
