// How finely a picture is drawn: as finely as the screen shows it, and coarser while pictures take too long, as they do
// where the processor draws them. Pure but for the look at the driver.

/** A picture is too expensive when the page's next frame comes later than this. */
const DEAR = 21; // ms
/** One that leaves so much room may be finer. */
const CHEAP = 17.5; // ms
const LEAST = 0.4;
const POOR = 0.55;
const COARSER = 0.8;
const FINER = 1.1;
/** So many pictures one after the other, before anything is changed. */
const PATIENCE = { coarser: 3, finer: 40, longest: 640 } as const;

export class Resolution {
  private scale = 1;
  private dear = 0;
  private cheap = 0;
  /** The last change was to a finer one. */
  private tried = false;
  /** Cheap pictures before the next try: more after each that was in vain, so that the picture does not pulsate. */
  private patience: number = PATIENCE.finer;

  private poor = false;

  /** Pictures take too long although they are coarse: something must be left away. */
  get isPoor(): boolean {
    return this.poor;
  }

  /** The share of the screen's own resolution. */
  get share(): number {
    return this.scale;
  }

  /** A picture was drawn; `ms`: until the page's next frame. True: the next one is to be drawn otherwise. */
  tell(ms: number): boolean {
    this.dear = ms > DEAR ? this.dear + 1 : 0;
    this.cheap = ms < CHEAP ? this.cheap + 1 : ms > DEAR ? 0 : this.cheap;
    const before = this.scale;
    if (ms < CHEAP) this.poor = false;
    if (this.dear >= PATIENCE.coarser) {
      this.poor = this.scale <= POOR;
      this.patience = this.tried ? Math.min(2 * this.patience, PATIENCE.longest) : PATIENCE.finer;
      this.change(COARSER);
    } else if (this.cheap >= this.patience) {
      this.change(FINER);
    }
    return this.scale !== before;
  }

  private change(factor: number): void {
    this.scale = Math.min(1, Math.max(LEAST, this.scale * factor));
    this.tried = factor === FINER;
    this.dear = 0;
    this.cheap = 0;
  }
}

let inSoftware: boolean | undefined;

/** Is there no graphics card, so that smooth edges and shadows cost several pictures' worth? */
export function drawsInSoftware(): boolean {
  return (inSoftware ??= looksLikeSoftware());
}

function looksLikeSoftware(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  if (context === null) return false;
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(info === null ? context.RENDERER : info.UNMASKED_RENDERER_WEBGL));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}
