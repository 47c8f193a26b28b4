import { canvasPng } from '../shell/canvasPng.ts';

/** Pixels of a saved PNG for each of the diagram's. */
const DENSITY = 2;

export const svgFile = (svg: string): Blob => new Blob([svg], { type: 'image/svg+xml' });

/** The diagram as PNG, drawn by the browser. */
export async function pngFile(svg: string, { width, height }: { width: number; height: number }): Promise<Blob> {
  const address = URL.createObjectURL(svgFile(svg));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = DENSITY * width;
    canvas.height = DENSITY * height;
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await canvasPng(canvas);
  } finally {
    URL.revokeObjectURL(address);
  }
}
