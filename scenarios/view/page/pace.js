// How much of a crowd is drawn while it moves: where drawing is slow, without a graphics card, every second or fourth
// body. At rest all are drawn.

const [slow, quick] = [0.09, 0.022]; // seconds between frames; far enough apart that no share goes to and fro
const fewest = 1 / 4;
const looked = 6; // frames

export class Pace {
  share = 1;
  intervals = [];

  /// Takes note of the seconds between two frames of a motion.
  note(passed) {
    this.intervals.push(passed);
    if (this.intervals.length < looked) return;
    const usual = this.intervals.sort((a, b) => a - b)[looked / 2];
    this.intervals = [];
    if (usual > slow) this.share = Math.max(this.share / 2, fewest);
    else if (usual < quick) this.share = Math.min(this.share * 2, 1);
  }
}
